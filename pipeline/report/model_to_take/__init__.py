"""The model to take for a material, the reason, its errors, and how to ask and export it."""
