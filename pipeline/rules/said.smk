from pipeline.report.ended import remove_stale, rewrite, unmade
from pipeline.report.failures import told


# What the workflow does and says when it starts, fails and ends: of what it was asked for, what is whole, no more.
def made():
    jobs = [job for job in workflow.dag.jobs if workflow.dag.noneedrun_finished(job)]
    return [str(file) for job in jobs for file in job.output]


def end(rewritten):
    # What a failure left was written by no job: those jobs run at the next start, whatever their inputs say.
    done = {str(file) for job in workflow.dag.jobs if workflow.dag.finished(job) for file in job.output}
    KNOWN.notes["again"] = sorted({*KNOWN.notes.get("again", []), *rewritten} - done)
    KNOWN.notes |= {run: KNOWN.digest(recorded_files(RAW, run, SYNTHETIC)) for run in SYNTHETIC}
    KNOWN.save()


onstart:
    if workflow.execution_settings.keep_going:
        shell.prefix(f"{PREFIX} NOTE_REFUSALS=--note-refusals; ")
    gone = remove_stale(KNOWN.notes.get("reports", []), REPORTS)
    for name in gone:
        print(f"{name}: removed, its run is gone")
    KNOWN.notes["reports"] = sorted({*KNOWN.notes.get("reports", []), *REPORTS} - set(gone))
    KNOWN.save()


onerror:
    jobs = list(workflow.dag.needrun_jobs())
    left = unmade(MATERIALS, DIAGNOSED, {str(file) for job in jobs for file in job.output})
    last = [job for name in ("metrics", "index") for job in jobs if job.rule.name == name]
    wrong = rewrite([job.shellcmd for job in last], left, [*TABLES, *FIGURES, *PAGES], workflow.basedir)
    print(summary(made(), Path("reports"), MATERIALS, DIAGNOSED))
    for line in wrong + [one.why for one in left]:
        print(line)
    failed = [
        (" ".join([job.rule.name, *map(str, job.wildcards)]), str(job.log)) for job in workflow.scheduler.failed
    ]
    print(told(failed, [one.why for one in PLAN.left_out], workflow.execution_settings.keep_going))
    KNOWN.forget_intact()
    end([str(file) for job in last for file in job.output])


onsuccess:
    print(summary(made(), Path("reports"), MATERIALS, DIAGNOSED))
    end([])
