"""Basics: units, parameters, validation, files and folders, optional dependencies, memory."""
