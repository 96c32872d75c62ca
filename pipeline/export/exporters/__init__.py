"""The exporter of each model, one file each: found by its model's name."""
