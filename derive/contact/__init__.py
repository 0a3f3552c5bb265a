"""Contact laws: from the motion before a contact to the motion after it (Eqs. 7-17)."""
