"""How each model is exported, a file a model: found by being here, under the model's name."""
