"""How a ball moves between contacts."""
