"""The event loop (Table 1): its stages, and the decisions in them."""
