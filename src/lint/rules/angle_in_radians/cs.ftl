W323 = zorný úhel `{ $angle }` stupně vypadá jako { $about }° v radiánech
    .label = úhel se píše ve stupních
    .note = obrázek tak zachytí jen nepatrnou část scény
    .fix = napsat `{ $degrees }`
W323-unusual = zorný úhel `{ $angle }`° je velmi malý; v radiánech by to bylo { $about }°
    .label = úhel se píše ve stupních
    .note = obrázek tak zachytí jen nepatrnou část scény
    .fix = napsat `{ $degrees }`
