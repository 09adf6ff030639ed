namespace talus { void sim_io_stub(); void sim_io_stub() {} }
