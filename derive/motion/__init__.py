"""The ball's path between contacts and in contact, as formulas in time."""
