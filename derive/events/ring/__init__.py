"""Event detection on the ring of Table 2: in double and single precision, and a miss filter."""
