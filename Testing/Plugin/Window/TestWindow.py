# SPDX-License-Identifier: BSD-3-Clause
"""Starts window_steps.py, which is a module: ParaView's programmable filters leave names of numpy in the script that it runs."""

from hands import start
from window_steps import steps

start(steps())
