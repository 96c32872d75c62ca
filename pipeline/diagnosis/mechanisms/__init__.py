"""The library: a file for each mechanism, found by being there, beside what a mechanism is and what several share."""
