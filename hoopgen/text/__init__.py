"""Text for people: shortened values, numbers, tables, and escapes for terminals and HTML."""
