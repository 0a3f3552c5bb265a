"""Scenes of one's own."""
