"""What all the house stands on: errors, files, tables that pass a door, units, the paper's equations."""
