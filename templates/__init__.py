"""How it is written: one folder of Jinja2 templates per target, the same base names in each."""
