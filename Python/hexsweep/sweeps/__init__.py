# SPDX-License-Identifier: BSD-3-Clause
"""Solids into meshes, and what is known of these."""
