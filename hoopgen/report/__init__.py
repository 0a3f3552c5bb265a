"""Descriptions of scenes, settings and results, in the units that coaches use."""
