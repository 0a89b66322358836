"""FRM: frames and poses."""

SOURCES = ("http://sdformat.org/tutorials?tut=pose_frame_semantics_proposal",)
