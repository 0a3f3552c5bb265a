"""What is true: the model of the article, in SymPy.

Every formula that hoopgen computes is written here, once. Nothing in this package knows a target
language, a file or a number of a particular hoop.
"""
