"""The project's own code as data: its modules, what they import, a fingerprint, a process for each of a list."""
