"""Imported, it makes the programs of this process cheap: what no test of the loop looks at is not drawn.

That is a diagnosis' page of figures, at which `tests/diagnosis` looks; the loop's own figures are drawn as ever. What
each diagnosis would read anew is read.
"""

from pipeline.diagnosis.drawing import figures
from pipeline.diagnosis.verdict import fingerprint
from pipeline.systems import systems

figures.page = lambda study, content, path, mark: None
fingerprint("pipeline.diagnose", "pipeline.diagnosis.*", "pipeline.systems.*")
systems()
