"""Tables of releases and of results: read, interpreted, filtered, written."""
