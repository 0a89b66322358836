"""FRM: frames and poses."""
