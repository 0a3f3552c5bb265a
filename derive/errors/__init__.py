"""How far a computed state can be from the true one."""
