"""Recovery of releases from the measured tracks of a ball."""
