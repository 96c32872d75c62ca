"""The capture program: a serial port → `raw/<run>/`, every byte as it came, and capture.json when it is done."""
