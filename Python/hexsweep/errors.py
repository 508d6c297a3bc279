# SPDX-License-Identifier: BSD-3-Clause
"""What goes wrong, and what is to be known."""


class SweepError(Exception):
    """Why there is no mesh, in words for the user: what is wrong, where, and how to mend it.

    Without text where that has been said already.
    """


class SweepWarning(UserWarning):
    """What is to be known of a mesh that is there: hexahedra that are not certified, input that was
    mended."""
