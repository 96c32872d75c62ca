"""The concealed proof: recordings of the synthetic rig with physics hidden in them, and sealed answers that name it."""
