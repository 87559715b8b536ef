# SPDX-License-Identifier: LGPL-3.0-or-later
"""The table of the audit, in Markdown, and its figures compared with those of program.toml."""

HEAD = """\
| program | what is lost | polynomial | box | grid | lost cells | far | features lost | false cells | far | promise |
| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |"""


def figures(judgement):
    return {"lost": len(judgement.lost), "lost_far": len(judgement.lost_far), "features": len(judgement.features),
            "features_lost": len(judgement.features_lost), "false": len(judgement.false),
            "false_far": len(judgement.false_far)}


def row(program, case, judgement):
    seen = figures(judgement)
    columns = [f"{program.title} {program.version}", case.loss, f"`{case.polynomial}`", case.box,
               " x ".join(map(str, case.counts)), f"{seen['lost']} of {len(judgement.hit)}", seen["lost_far"],
               f"{seen['features_lost']} of {seen['features']}", seen["false"], seen["false_far"], program.promise]
    return f"| {' | '.join(map(str, columns))} |"


def complaints(program, case, judgement):
    """One for each figure that differs from that of the case."""
    return [f"{program.title}, {case.name}: {name} is {value}; expected {getattr(case, name)}"
            for name, value in figures(judgement).items() if value != getattr(case, name)]
