"""JNT: joints."""
