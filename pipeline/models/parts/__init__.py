"""What models are made of: inputs, fits, training, intervals, and how a fitted model is stored."""
