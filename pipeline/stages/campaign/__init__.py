"""A campaign over many strings: what was learnt on some is asked about others."""
