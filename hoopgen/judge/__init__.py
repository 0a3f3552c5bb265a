"""The judge: what a shot does, proved in ball arithmetic, apart from the engines."""

from __future__ import annotations

from hoopgen.core.extras import explain_import_error

try:
    import flint as _flint  # noqa: F401
    import sympy as _sympy  # noqa: F401
except ImportError as error:
    raise explain_import_error(error, "certify", extra="certify") from None

from .batch import MAX_BITS, CertificationOptions, certify
from .certificate import Certificate
from .proof import UNDECIDED, Enclosure, Proof
from .release_box import BoxProof, certify_box

__all__ = [
    "MAX_BITS",
    "UNDECIDED",
    "BoxProof",
    "Certificate",
    "CertificationOptions",
    "Enclosure",
    "Proof",
    "certify",
    "certify_box",
]
