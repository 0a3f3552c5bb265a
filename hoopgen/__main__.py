"""``python -m hoopgen``: the command line."""

from hoopgen.cli import main

main()
