"""The project's own code as data: its modules, their imports, a fingerprint, and a process for each item of a list."""
