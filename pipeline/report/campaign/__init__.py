"""The campaign's page: what a new string teaches a model."""
