"""The stages of the workflow, one program each, named as its rule is and as its output is."""
