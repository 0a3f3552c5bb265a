"""Recovery from measurements: releases from tracks, restitution and friction from outcomes."""
