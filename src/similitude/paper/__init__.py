"""The paper, reproduced: its equations, figures and claims beside what this package computes.

`printed` what the paper states · `claim` one checked statement · `equations*` each equation against the
code that implements it · `claims_*` one file a subject · `drives`, `seven`, `bound`, `ahead` the runs behind
them · `pictures*` the figures · `reproduction` all of it at once · `companion` the page · `folder` the files.

Source: S. Brennan, A. Alleyne, Real-time identification of vehicle chassis dynamics using a novel
reparameterization based on sensitivity invariance, Int. J. Adaptive Control Signal Processing 18 (2004).
"""
