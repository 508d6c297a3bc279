# SPDX-License-Identifier: BSD-3-Clause
"""Files of solids and meshes: read, written, checked, put in place when they are whole."""
