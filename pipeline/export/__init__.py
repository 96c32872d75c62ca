"""Fitted models as code for a controller: a C99 header without dependencies, or ONNX graphs."""
