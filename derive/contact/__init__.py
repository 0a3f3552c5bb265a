"""What a contact makes of the ball's motion: the contact frame, and the laws."""
