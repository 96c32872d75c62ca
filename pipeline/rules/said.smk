import signal

import snakemake.exceptions
from snakemake.exceptions import WorkflowError

from pipeline.ground.errors import BadInput
from pipeline.report.end_of_job.stale_reports import remove_stale, rewrite, unmade
from pipeline.report.end_of_job.failures import STOPPED, concerned, told, without
from pipeline.report.left_out import noted_in


# What a second start in this folder is told while a first one holds its files.
class Busy(WorkflowError):
    def __init__(self):
        super().__init__(
            "A main job runs in this folder already, and makes the same files: wait until it has ended, then run this"
            " again. If it was killed, python3 env/run.py snakemake … removes the locks that it left."
        )


snakemake.exceptions.LockException = Busy


# Without a shared file system nothing of the results is here.
ELSEWHERE = f"what was made lies in the storage: {workflow.storage_settings.default_storage_prefix}" if COPY else ""


# A person's Ctrl-C ends the jobs as well, and their errors are no failures.
ASKED_TO_STOP = []


def stop(number, frame):
    ASKED_TO_STOP.append(number)
    signal.default_int_handler(number, frame)


if signal.getsignal(signal.SIGINT) is signal.default_int_handler:
    signal.signal(signal.SIGINT, stop)


# What the workflow does and says when it starts, fails and ends: of what it was asked for, what is whole, no more.
def made():
    jobs = [job for job in workflow.dag.jobs if workflow.dag.noneedrun_finished(job)]
    return [str(file) for job in jobs for file in job.output]


def left():
    # By the plan, and by the stages of what the workflow was asked for. An unreadable note is made again at the next start.
    there = {str(file) for job in workflow.dag.jobs for file in job.output}
    of_all = any(job.rule.name == "tables" for job in workflow.dag.jobs)  # of every material, also of one without a run
    planned = PLAN.left_out if of_all else concerned(PLAN.left_out, there)
    try:
        found = noted_in(path for path in map(Path, LEFT_OUT) if str(path) in there and path.is_file())
    except BadInput:
        found = []
    return [one.why for one in dict.fromkeys([*planned, *found])]


def end(rewritten):
    # What a failure left was written by no job: those jobs run at the next start, whatever their inputs say.
    done = {str(file) for job in workflow.dag.jobs if workflow.dag.finished(job) for file in job.output}
    KNOWN.notes["again"] = sorted({*KNOWN.notes.get("again", []), *rewritten} - done)
    KNOWN.notes |= {run: KNOWN.digest(recorded_files(RAW, run, SYNTHETIC)) for run in SYNTHETIC}
    KNOWN.save()


onstart:
    if workflow.execution_settings.keep_going:
        os.environ[handed_plan.REFUSALS] = "--note-refusals"  # for nodes; here the prefix says so
        shell.prefix(f"{PREFIX} NOTE_REFUSALS=--note-refusals; ")
    gone = remove_stale(KNOWN.notes.get("reports", []), REPORTS)
    for name in gone:
        print(f"{name}: removed, its run is gone")
    KNOWN.notes["reports"] = sorted({*KNOWN.notes.get("reports", []), *REPORTS} - set(gone))
    KNOWN.save()


onerror:
    jobs = list(workflow.dag.needrun_jobs())
    lost = unmade(MATERIALS, DIAGNOSED, {str(file) for job in jobs for file in job.output})
    last = [job for name in ("metrics", "index") for job in jobs if job.rule.name == name]
    wrong = [] if COPY else rewrite([job.shellcmd for job in last], lost, OF_MATERIAL, workflow.basedir)
    print(ELSEWHERE or summary(made(), Path("reports"), MATERIALS, DIAGNOSED, names_with_motion()))
    for line in wrong + [one.why for one in lost]:
        print(line)
    failed = [
        (" ".join([job.rule.name, *map(str, job.wildcards)]), str(job.log)) for job in workflow.scheduler.failed
    ]
    print(STOPPED if ASKED_TO_STOP else told(failed, left(), workflow.execution_settings.keep_going))
    KNOWN.forget_intact()
    end([str(file) for job in last for file in job.output])


onsuccess:
    print(ELSEWHERE or summary(made(), Path("reports"), MATERIALS, DIAGNOSED, names_with_motion()))
    print(without(left()))
    end([])
