"""The improved simulator alone: of recorded, later and planned motion, with its band and a black box beside."""
