"""The contact phase: from accumulated bounces to departure, rest or endless rolling."""
