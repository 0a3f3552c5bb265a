"""What happens to a shot, in order (Table 1): the fields it has, and the event loop as data."""
