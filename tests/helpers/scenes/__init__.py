"""Scenes that are not the article's: what only knows the hoop fails on them."""
