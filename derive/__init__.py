"""The mathematics, in SymPy: the article's model, its extensions, and bounds on their errors."""
