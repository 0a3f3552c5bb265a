"""Quantities measured of shots beside their outcome: entry, clearance, rebounds."""
