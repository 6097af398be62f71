"""Pictures."""

from typing import TYPE_CHECKING

from lommel.base import lazy

if TYPE_CHECKING:
    from lommel.show import fit as fit
    from lommel.show import notebook as notebook
    from lommel.show import plot as plot
else:
    __getattr__, __dir__ = lazy.parts(__name__)
