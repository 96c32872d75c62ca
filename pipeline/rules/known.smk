import socket

from pipeline.report.end_of_job.failures import told_at_start
from pipeline.workflow.dag import output_of

# What a start finds before it plans: folders that cannot be runs, stored files that are damaged, recordings that changed.
DAMAGED, REPLACED, AGAIN = {}, [], set()
if ON_NODE:  # its start has looked: a node looks for nothing and keeps nothing, and says where it is
    print(f"node: {os.environ.get('SLURMD_NODENAME') or socket.gethostname()}", file=sys.stderr)
elif not COPY:
    LEAKED = sorted({figure.split("/")[1] for figure in LEAK_FIGURES})
    STORED = [
        *stored(config["models"], PLAN),
        *expand(rules.floor.output, material=MATERIALS),
        *expand(rules.train_leak.output, material=LEAKED, variant=LEAKING, seed=LEAK_SEEDS),
        *expand(rules.leak.output, material=LEAKED),
    ]
    DAMAGED = KNOWN.damaged(STORED)
    REPLACED = [run for run in SYNTHETIC if KNOWN.notes.get(run, CONTENT[run]) != CONTENT[run]]
    AGAIN = {*map(output_of, DAMAGED), *(f"raw/{run}/run.yaml" for run in REPLACED), *KNOWN.notes.get("again", [])}
    KNOWN.save()

# Every report that a run or a material asks for, be it bad for now.
ASKED = [*MATERIALS, *(one.material for one in PLAN.refused if one.material)]
REPORTED = [*DIAGNOSED, *(one.run for one in PLAN.left_out)]
REPORTS = [
    *expand("reports/{material}/{file}", material=ASKED, file=OF_MATERIAL),
    *LEAK_FIGURES,
    *(f"reports/diagnosis/{run}" for run in REPORTED),
]

for line in [] if ON_NODE else told_at_start(PLAN.left_out, sys.argv):
    print(line, file=sys.stderr)
for name, wrong in DAMAGED.items():
    print(f"{name}: is damaged, or of an earlier version ({wrong}): it is made again", file=sys.stderr)
for run in REPLACED:
    print(f"raw/{run}: is not what the synthetic rig recorded: it is recorded again", file=sys.stderr)
