"""The hoop: presets, releases and their variables, kinds of shots."""
