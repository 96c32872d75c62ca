"""The page of figures: each panel draws one thing of a diagnosis."""
