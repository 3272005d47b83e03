"""Ten lines for those who come from pyweaving: reads a draft and prints its drawdown, end 1 at the right, pick 1 on top.

python3 read_a_draft.py DRAFT.wif
"""

import sys

import weftlight

draft = weftlight.read(sys.argv[1])
for remark in draft.diagnostics:
    print(f"line {remark.line}: {remark.text}; {remark.remedy}", file=sys.stderr)
design = draft.design
print(f"{design.title}: {design.ends} ends, {design.picks} picks, {design.shafts} shafts, {design.treadles} treadles")
for pick in design.drawdown()[:, ::-1]:
    print("".join("#" if warp_up else "." for warp_up in pick))
