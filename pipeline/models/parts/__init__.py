"""The parts of models: inputs, fits, training, intervals, and the storage of fitted models."""
