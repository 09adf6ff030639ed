namespace talus { void app_stub(); void app_stub() {} }
