"""Error propagation: the derivative of a flight and a contact, and the growth that it bounds."""
