"""What only a hoop has: presets, releases and their variables, kinds of outcome."""
