"""The tests, by the package that they test; `helpers` is what they share."""
