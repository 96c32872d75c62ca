"""A campaign over many strings: models learn on some strings and are asked about others."""
