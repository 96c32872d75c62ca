"""What is foretold of motion that nobody recorded, by each explanation and by the improved simulator."""
